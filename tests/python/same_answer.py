"""A program of docs/examples and its twin in Python print the same: same_answer.py PROGRAM TWIN.py ARGUMENTS ..."""
import subprocess
import sys

try:
    import numpy  # noqa: F401
except ImportError:
    print("skipped: numpy is not there (python3-numpy)")
    sys.exit(77)

program, twin, *arguments = sys.argv[1:]
wanted = subprocess.run([program, *arguments], capture_output=True, text=True)
found = subprocess.run([sys.executable, twin, *arguments], capture_output=True, text=True)
print(found.stdout, found.stderr, sep="")
if (found.returncode, found.stdout) != (wanted.returncode, wanted.stdout):
    print("The program prints otherwise:", wanted.stdout, wanted.stderr, sep="\n")
    sys.exit(1)

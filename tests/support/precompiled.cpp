// Nothing: its program exists so that the headers that most tests include are compiled once, by the same options.

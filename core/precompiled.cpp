// Nothing: its library exists so that the headers that most rooms include are compiled once, by the same options.

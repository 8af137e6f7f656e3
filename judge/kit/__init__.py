"""What all commands of the kit share: paths, errors, files, text, command lines."""

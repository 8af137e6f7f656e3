"""What every command of the kit stands on: paths, errors, files, text, command lines."""

"""Which idea a wrong program misses: it is run on a gallery of tiny scenes, one lesson each."""

"""Does not compile, in words that move a cursor. Expect: CE"""

x = "[2J[H AC  100 of 100 points" y

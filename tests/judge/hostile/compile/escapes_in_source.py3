"""Does not compile; the line in the message holds escape sequences. Expect: CE"""

x = "[2J[H AC  100 of 100 points" y

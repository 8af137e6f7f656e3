/* Makes the compiler print escape sequences. Expect: CE */
#pragma message "[2J[H AC  100 of 100 points"
#error [2J[H AC  100 of 100 points

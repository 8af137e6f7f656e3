/* Makes the compiler print what moves a cursor. Expect: CE */
#pragma message "[2J[H AC  100 of 100 points"
#error [2J[H AC  100 of 100 points

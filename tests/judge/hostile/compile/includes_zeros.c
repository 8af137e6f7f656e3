/* Includes a file that never ends. Expect: CE */
#include "/dev/zero"

int main(void) { return 0; }

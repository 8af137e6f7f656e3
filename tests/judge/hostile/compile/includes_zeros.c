/* Includes a file without an end. Expect: CE */
#include "/dev/zero"

int main(void) { return 0; }

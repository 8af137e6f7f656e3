/* Includes its own input, which is empty, and hangs where it is not. Expect: AC CE */
#include "/dev/stdin"

#include <stdio.h>

int main(void) {
    for (int c; (c = getchar()) != EOF;) putchar(c);
}

/* Includes the compiler's standard input, which is empty or refused. Expect: AC CE */
#include "/dev/stdin"

#include <stdio.h>

int main(void) {
    for (int c; (c = getchar()) != EOF;) putchar(c);
}

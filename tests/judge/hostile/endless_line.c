/* Prints one line for ever. Expect: OLE */
#include <stdio.h>

int main(void) {
    for (;;) putchar('Y');
}

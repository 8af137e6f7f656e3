/* Prints for ever. Expect: OLE */
#include <stdio.h>

int main(void) {
    for (;;) puts("YES");
}

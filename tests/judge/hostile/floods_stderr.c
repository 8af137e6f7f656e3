/* Prints to standard error for ever. Expect: OLE */
#include <unistd.h>

int main(void) {
    static const char complaint[1 << 16];
    for (;;) (void)!write(2, complaint, sizeof complaint);
}

// Does not compile: the first statement lacks its semicolon.

#include <cstdio>

int main() {
    int scenarios = 0
    if (scanf("%d", &scenarios) != 1) return 1;
    while (scenarios-- > 0) puts("YES");
}

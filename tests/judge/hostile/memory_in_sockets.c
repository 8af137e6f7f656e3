/* Fills sockets that nobody reads, in many processes. Expect: MLE */
#include <fcntl.h>
#include <stdio.h>
#include <sys/socket.h>
#include <unistd.h>

static char block[4096];

static void fill(void) {
    int ends[2];
    while (socketpair(AF_UNIX, SOCK_STREAM, 0, ends) == 0)
        for (int i = 0; i < 2; i++) {
            fcntl(ends[i], F_SETFL, O_NONBLOCK);
            while (write(ends[i], block, sizeof block) > 0) continue;
        }
}

int main(void) {
    for (int i = 0; i < 12; i++)
        if (fork() == 0) {
            fill();
            sleep(5);
            return 0;
        }
    sleep(2);
    puts("YES");
}

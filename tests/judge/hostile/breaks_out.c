/* Answers right only if one of many ways to more privileges works. Expect: WA */
#define _GNU_SOURCE
#include <fcntl.h>
#include <sched.h>
#include <stdio.h>
#include <sys/ioctl.h>
#include <sys/mount.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <unistd.h>

static int raised(int what) {
    struct rlimit limit;
    getrlimit(what, &limit);
    if (limit.rlim_max == RLIM_INFINITY) return 0;
    limit.rlim_cur = limit.rlim_max = limit.rlim_max + 1;
    return setrlimit(what, &limit) == 0;
}

int main(void) {
    int gained = 0;
    gained |= setuid(0) == 0 || seteuid(0) == 0 || setgid(0) == 0;
    gained |= unshare(CLONE_NEWUSER) == 0 || unshare(CLONE_NEWNS) == 0 || unshare(CLONE_NEWPID) == 0;
    gained |= mount("", "/usr", "", MS_REMOUNT, "") == 0;
    gained |= mount("t", "/tmp", "tmpfs", 0, "") == 0 || umount("/tmp") == 0;
    gained |= chroot("/tmp") == 0;
    gained |= ptrace(PTRACE_ATTACH, getppid(), 0, 0) == 0;
    gained |= ptrace(PTRACE_TRACEME, 0, 0, 0) == 0;
    gained |= socket(AF_INET, SOCK_STREAM, 0) >= 0 || socket(AF_UNIX, SOCK_STREAM, 0) >= 0;
    gained |= socket(AF_NETLINK, SOCK_RAW, 0) >= 0;
    gained |= raised(RLIMIT_NPROC) || raised(RLIMIT_CPU) || raised(RLIMIT_FSIZE);
    gained |= raised(RLIMIT_STACK) || raised(RLIMIT_CORE);
    gained |= setpriority(PRIO_PROCESS, 0, -5) == 0;
    gained |= open("/usr/gained", O_CREAT | O_WRONLY, 0666) >= 0;
    gained |= open("/program/gained", O_CREAT | O_WRONLY, 0666) >= 0;
    gained |= open("/dev/gained", O_CREAT | O_WRONLY, 0666) >= 0;
    gained |= open("/dev/mem", O_RDONLY) >= 0 || open("/dev/kmsg", O_RDONLY) >= 0;
    gained |= open("/dev/sda", O_RDONLY) >= 0 || open("/dev/vda", O_RDONLY) >= 0;
    gained |= open("/proc/sys/kernel/hostname", O_WRONLY) >= 0;
    gained |= open("/proc/sysrq-trigger", O_WRONLY) >= 0;
    gained |= ioctl(0, TIOCSTI, "x") == 0 || ioctl(0, TIOCLINUX, "x") == 0;
    gained |= open("/dev/tty", O_RDWR) >= 0;
    gained |= syscall(SYS_bpf, 0, 0, 0) >= 0 || syscall(SYS_io_uring_setup, 4, 0) >= 0;
    gained |= syscall(SYS_keyctl, 0, -3, 1) >= 0;
    for (int c; gained && (c = getchar()) != EOF;) putchar(c);
}

/* Preloaded (LD_PRELOAD): a system whose clock jumps by ODD_CLOCK seconds to and fro, once a call, and, with ODD_LOCKS,
   whose files cannot be locked. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <time.h>

int clock_gettime(clockid_t clock, struct timespec* time)
{
    static atomic_long calls;
    int const result = ((int (*)(clockid_t, struct timespec*))dlsym(RTLD_NEXT, "clock_gettime"))(clock, time);
    char const* jump = getenv("ODD_CLOCK");
    if (jump && clock == CLOCK_REALTIME)
        time->tv_sec += (atomic_fetch_add(&calls, 1) % 2 ? 1 : -1) * atol(jump);
    return result;
}

int fcntl(int descriptor, int command, ...)
{
    va_list list;
    va_start(list, command);
    void* argument = va_arg(list, void*);
    va_end(list);
    if (getenv("ODD_LOCKS") && (command == F_OFD_SETLK || command == F_OFD_GETLK || command == F_SETLK)) {
        errno = ENOLCK;
        return -1;
    }
    return ((int (*)(int, int, ...))dlsym(RTLD_NEXT, "fcntl"))(descriptor, command, argument);
}

/* The name by which programs with large files call it. */
int fcntl64(int descriptor, int command, ...) __attribute__((alias("fcntl")));

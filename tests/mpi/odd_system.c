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

static int lock_or_call(char const* name, int descriptor, int command, void* argument)
{
    if (getenv("ODD_LOCKS") && (command == F_OFD_SETLK || command == F_OFD_GETLK || command == F_SETLK)) {
        errno = ENOLCK;
        return -1;
    }
    return ((int (*)(int, int, ...))dlsym(RTLD_NEXT, name))(descriptor, command, argument);
}

int fcntl(int descriptor, int command, ...)
{
    va_list list;
    va_start(list, command);
    void* argument = va_arg(list, void*);
    va_end(list);
    return lock_or_call("fcntl", descriptor, command, argument);
}

int fcntl64(int descriptor, int command, ...)
{
    va_list list;
    va_start(list, command);
    void* argument = va_arg(list, void*);
    va_end(list);
    return lock_or_call("fcntl64", descriptor, command, argument);
}

/* Preloaded (LD_PRELOAD), makes one call to the disk fail with EIO: the FAIL_AT-th of those named by FAIL_CALLS
   (e.g. "pwrite,fsync"; absent: all) on a path that contains FAIL_PATH. With FAIL_RANK only on that rank of
   Open MPI. FAIL_COUNT names a file to which the number of such calls is written when the program ends. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>
#include <unistd.h>

static atomic_long calls;

static int is_here(char const* path)
{
    char const* part = getenv("FAIL_PATH");
    char const* wanted = getenv("FAIL_RANK");
    char const* rank = getenv("OMPI_COMM_WORLD_RANK");
    if (wanted && strcmp(wanted, rank ? rank : "0") != 0)
        return 0;
    return part && strstr(path, part) != NULL;
}

/* Whether this call is the one that fails. */
static int fails(char const* call, char const* path)
{
    char const* list = getenv("FAIL_CALLS");
    char const* at = getenv("FAIL_AT");
    if ((list && !strstr(list, call)) || !is_here(path))
        return 0;
    long const number = atomic_fetch_add(&calls, 1) + 1;
    if (!at || atol(at) != number)
        return 0;
    char const* told = getenv("FAIL_TOLD");
    if (told) {
        int const out = open(told, O_WRONLY | O_CREAT | O_APPEND, 0666);
        dprintf(out, "%s %s\n", call, path);
        ((int (*)(int))dlsym(RTLD_NEXT, "close"))(out);
    }
    errno = EIO;
    return 1;
}

static int fails_on(char const* call, int descriptor)
{
    char link[64], path[4096];
    int const saved = errno;
    snprintf(link, sizeof link, "/proc/self/fd/%d", descriptor);
    ssize_t const length = readlink(link, path, sizeof path - 1);
    errno = saved;
    if (length <= 0)
        return 0;
    path[length] = 0;
    return fails(call, path);
}

#define REAL(type, name, ...)                                                                                \
    static type (*real)(__VA_ARGS__);                                                                        \
    if (!real)                                                                                               \
    real = (type(*)(__VA_ARGS__))dlsym(RTLD_NEXT, name)

ssize_t pwrite(int file, void const* data, size_t size, off_t place)
{
    REAL(ssize_t, "pwrite", int, void const*, size_t, off_t);
    return fails_on("pwrite", file) ? -1 : real(file, data, size, place);
}
ssize_t pwrite64(int file, void const* data, size_t size, off_t place)
{
    REAL(ssize_t, "pwrite64", int, void const*, size_t, off_t);
    return fails_on("pwrite", file) ? -1 : real(file, data, size, place);
}
ssize_t write(int file, void const* data, size_t size)
{
    REAL(ssize_t, "write", int, void const*, size_t);
    return fails_on("write", file) ? -1 : real(file, data, size);
}
ssize_t pread(int file, void* data, size_t size, off_t place)
{
    REAL(ssize_t, "pread", int, void*, size_t, off_t);
    return fails_on("pread", file) ? -1 : real(file, data, size, place);
}
ssize_t pread64(int file, void* data, size_t size, off_t place)
{
    REAL(ssize_t, "pread64", int, void*, size_t, off_t);
    return fails_on("pread", file) ? -1 : real(file, data, size, place);
}
ssize_t read(int file, void* data, size_t size)
{
    REAL(ssize_t, "read", int, void*, size_t);
    return fails_on("read", file) ? -1 : real(file, data, size);
}
int fsync(int file)
{
    REAL(int, "fsync", int);
    return fails_on("fsync", file) ? -1 : real(file);
}
int fdatasync(int file)
{
    REAL(int, "fdatasync", int);
    return fails_on("fdatasync", file) ? -1 : real(file);
}
int ftruncate(int file, off_t size)
{
    REAL(int, "ftruncate", int, off_t);
    return fails_on("ftruncate", file) ? -1 : real(file, size);
}
int ftruncate64(int file, off_t size)
{
    REAL(int, "ftruncate64", int, off_t);
    return fails_on("ftruncate", file) ? -1 : real(file, size);
}
/* The descriptor is closed even where it fails, as Linux does. */
int close(int file)
{
    REAL(int, "close", int);
    int const failing = fails_on("close", file);
    int const result = real(file);
    if (failing)
        errno = EIO;
    return failing ? -1 : result;
}
int rename(char const* from, char const* to)
{
    REAL(int, "rename", char const*, char const*);
    return fails("rename", to) ? -1 : real(from, to);
}

__attribute__((destructor)) static void tell_count(void)
{
    char const* name = getenv("FAIL_COUNT");
    FILE* out = name && is_here(getenv("FAIL_PATH") ? getenv("FAIL_PATH") : "") ? fopen(name, "w") : NULL;
    if (out) {
        fprintf(out, "%ld\n", (long)atomic_load(&calls));
        fclose(out);
    }
}

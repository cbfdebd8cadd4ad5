/* What the shared library exports: everything else of it is hidden (-fvisibility=hidden).
 *
 * QUELL_API marks what C++ programs call or catch, QUELL_HIDDEN what is not for them though it is part of such a class;
 * functions of C stand between QUELL_C_API_BEGIN and QUELL_C_API_END. */
#ifndef QUELL_API_H
#define QUELL_API_H

#if defined(__GNUC__)
#define QUELL_API __attribute__((visibility("default")))
#define QUELL_HIDDEN __attribute__((visibility("hidden")))
#define QUELL_EXPORT_BEGIN _Pragma("GCC visibility push(default)")
#define QUELL_EXPORT_END _Pragma("GCC visibility pop")
#else
#define QUELL_API
#define QUELL_HIDDEN
#define QUELL_EXPORT_BEGIN
#define QUELL_EXPORT_END
#endif

#ifdef __cplusplus
#define QUELL_C_API_BEGIN QUELL_EXPORT_BEGIN extern "C" {
#define QUELL_C_API_END \
  }                     \
  QUELL_EXPORT_END
#else
#define QUELL_C_API_BEGIN QUELL_EXPORT_BEGIN
#define QUELL_C_API_END QUELL_EXPORT_END
#endif

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// DSC_ASSERT: a programmer's error, checked in Debug builds and in CI (DSC_CHECKED), gone in Release.
// Bad input never ends here: it raises one of the exceptions of core/errors.h.
#pragma once

#if !defined(NDEBUG) || defined(DSC_CHECKED)
namespace dsc::core {
[[noreturn]] void assertion_failed(const char* condition, const char* file, int line);
}
#define DSC_ASSERT(condition) \
    ((condition) ? static_cast<void>(0) : ::dsc::core::assertion_failed(#condition, __FILE__, __LINE__))
#else
#define DSC_ASSERT(condition) static_cast<void>(0)
#endif

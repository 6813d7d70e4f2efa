// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/Vec.h"

#include <cstddef>
#include <cstdint>
#include <cstring>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

/// Writing past the caches, where the processor can: a mesh larger than they are would push out all else, and each line
/// of it be read before it is written. What is streamed must be written from front to end.
namespace toile::meshing {

using geometry::Vec2;

/// A mesh of so many bytes is streamed.
constexpr std::size_t streamedFrom = std::size_t{64} << 20;

#ifdef __SSE2__
inline void stream(Vec2* to, Vec2 value) { // vectors of it are aligned
    _mm_stream_pd(&to->x, _mm_setr_pd(value.x, value.y));
}
inline void stream(void* to, std::int32_t value) {
    _mm_stream_si32(static_cast<int*>(to), value);
}
inline void stream(void* to, std::int64_t value) {
    _mm_stream_si64(static_cast<long long*>(to), value);
}
/// Other threads see what was streamed.
inline void endStreaming() {
    _mm_sfence();
}
#else
template <class T, class Value>
void stream(T* to, Value value) {
    std::memcpy(to, &value, sizeof value);
}
inline void endStreaming() {}
#endif

} // namespace toile::meshing

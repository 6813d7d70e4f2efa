// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <utility>

namespace toile {

enum class ErrorCode {
    invalidInput, ///< the file, the document or a setting is wrong
    notFound,     ///< a file or a named thing does not exist
    unsupported,  ///< right, but not offered (a newer version, an option not built)
    tooLarge,     ///< would exceed the memory or time we allow ourselves
    notConverged, ///< a computation did not reach its goal
    cancelled,    ///< the user stopped it
    io,           ///< the operating system refused
};

/// Where in the user's world something is wrong. Empty parts are unknown.
struct Place {
    std::string file;
    int line = 0;       ///< of the file, from 1; 0 = unknown
    std::string path;   ///< in the document, e.g. "pieces[2].vertices[0].x"
    std::string object; ///< the user's words: piece "Back", edge "armhole"

    friend bool operator==(const Place&, const Place&) = default;
};

/// "blouse.toile:12: pieces[2].spacing", as far as the parts are known.
std::string toString(const Place& place);

struct Error {
    ErrorCode code = ErrorCode::invalidInput;
    std::string text; ///< one sentence for the user: what, and what to do
    Place place;

    friend bool operator==(const Error&, const Error&) = default;
};

/// "FILE: place: sentence" on one line.
std::string toString(const Error& error);

/// A remark that does not stop the work.
struct Warning {
    std::string place; ///< the user's words
    std::string text;

    friend bool operator==(const Warning&, const Warning&) = default;
};

template <class T>
using Result = tl::expected<T, Error>;

/// return fail(ErrorCode::invalidInput, "The spacing must be positive.", {.object = "piece \"Back\""});
inline tl::unexpected<Error> fail(ErrorCode code, std::string text, Place place = {}) {
    return tl::unexpected<Error>(Error{code, std::move(text), std::move(place)});
}

} // namespace toile

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pattern/PatternCheck.h"

#include <set>
#include <string>

namespace toile::pattern {

/// Collects the problems of one thing: its path in the document and the user's words for it go with each.
class Problems {
public:
    Problems(std::vector<Problem>& all, std::string path, std::string object)
        : all_(all), path_(std::move(path)), object_(std::move(object)) {}

    /// `member` is appended to the path: "spacing", "vertices[3].x".
    void error(const std::string& member, std::string text) { add(member, std::move(text), true); }
    void warning(const std::string& member, std::string text) { add(member, std::move(text), false); }

private:
    void add(const std::string& member, std::string text, bool isError) {
        const char* separator = path_.empty() || member.empty() ? "" : ".";
        all_.push_back({{.path = path_ + separator + member, .object = object_}, std::move(text), isError});
    }

    std::vector<Problem>& all_;
    std::string path_, object_;
};

constexpr double checkedChordError = 5e-5; ///< contours are looked at as polygons so near [m]

/// A length as problems tell it [mm].
[[nodiscard]] constexpr double mm(double metres) {
    return metres * 1000;
}

/// Numbers, crossings, orientation and nesting of a piece's contours. Returns whether they can be worked with.
bool checkContours(const Piece& piece, Problems& problems);
/// Regions of a piece whose contours are sound.
void checkRegions(const Piece& piece, Problems& problems);
/// Folds of a piece whose contours are sound.
void checkFolds(const Piece& piece, Problems& problems);
/// Seams, one by one and against each other. Lengths and directions are not looked at where a contour is unsound.
void checkSeams(const Pattern& pattern, const std::set<PieceId>& unsound, const SeamTolerance& tolerance,
                std::vector<Problem>& problems);
/// Neighbouring parts of a seam's side, whose edges there are, must follow one another; one that would follow if it
/// were walked the other way is turned wrongly.
void checkChain(const Pattern& pattern, const std::vector<SeamPart>& side, const std::string& at, Problems& problems);
/// Tacks. Places are not looked at where a contour is unsound.
void checkTacks(const Pattern& pattern, const std::set<PieceId>& unsound, std::vector<Problem>& problems);

} // namespace toile::pattern

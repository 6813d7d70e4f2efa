// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/stability/StiffnessMap.h"
#include "core/study/stability/Watch.h"

#include <string_view>
#include <vector>

namespace toile::study::stability {

enum class Verdict {
    pass,
    passWithWarning, ///< right, and the user is told what is unusual
    refused,         ///< with a sentence, where that is right
    fail
};
[[nodiscard]] std::string_view nameOf(Verdict verdict);

/// One line of the table.
struct Row {
    std::string number; ///< "S3"
    std::string what;
    Metrics metrics;
    Verdict verdict = Verdict::pass;
    std::string why; ///< the reason of every verdict but a plain pass
};

/// What is asked of a case.
struct Effort {
    bool quick = false; ///< coarser and shorter
};

/// What a case leaves: rows, and S1 its map.
struct Findings {
    std::vector<Row> rows;
    std::vector<MapCell> map;
};

/// Something extreme that a user or a file may ask for.
struct Case {
    std::string_view number, title;
    Findings (*run)(const Effort&) = nullptr;
};
[[nodiscard]] std::vector<Case> allCases();

/// A row by the rules of its method: bounded energy and solved steps. What ended early fails.
[[nodiscard]] Row judged(std::string number, std::string what, const Watched& run, dynamics::Method method);
/// A row of something that must be refused with a sentence.
[[nodiscard]] Row mustBeRefused(std::string number, std::string what, const std::string& sentence);
/// A row of a test of one's own.
[[nodiscard]] Row tested(std::string number, std::string what, bool passes, std::string why, Metrics metrics = {});

/// The chapters, one per file of this folder.
[[nodiscard]] std::vector<Case> stiffnessCases();
[[nodiscard]] std::vector<Case> degenerateCases();
[[nodiscard]] std::vector<Case> loadCases();
[[nodiscard]] std::vector<Case> contactCases();
[[nodiscard]] std::vector<Case> sewingCases();
[[nodiscard]] std::vector<Case> enduranceCases();
[[nodiscard]] std::vector<Case> handCases();
[[nodiscard]] std::vector<Case> fileCases();
[[nodiscard]] std::vector<Case> motionCases();
[[nodiscard]] std::vector<Case> skirtCases();
[[nodiscard]] std::vector<Case> sizeCases();
[[nodiscard]] std::vector<Case> pleatCases();

} // namespace toile::study::stability

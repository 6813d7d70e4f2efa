// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"

#include <string>
#include <vector>

namespace toile::study::validation {

/// One line of the table of cases.
struct Row {
    std::string number;   ///< "V5"
    std::string what;     ///< what was measured, and how finely
    bool isBound = false; ///< `expected` may not be exceeded; else it is to be met
    double expected = 0;
    double measured = 0;
    double tolerance = 0; ///< relative to `expected` [–]; of a bound 0
    std::string stopped;  ///< why there is nothing measured; else empty

    [[nodiscard]] bool passes() const;
};

/// "V5    cantilever Γ=10, 16 cells    expected 1.0668  measured 1.07449  tolerance 0.01  PASS"
[[nodiscard]] std::string lineOf(const Row& row);

/// What a case finds, row by row.
class Findings {
public:
    explicit Findings(std::string number) : number_(std::move(number)) {}

    void within(std::string what, double expected, double measured, double tolerance);
    void atMost(std::string what, double bound, double measured);

    /// Whether a step succeeded; a row says why where it did not. Only the first such row is kept: what comes of the
    /// rest says nothing.
    template <class T>
    bool ran(const Result<T>& result) {
        if (!result) stop(toString(result.error()));
        return result.has_value();
    }
    void stop(const std::string& why);
    [[nodiscard]] bool stopped() const { return stopped_; }

    [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }

private:
    std::string number_;
    std::vector<Row> rows_;
    bool stopped_ = false;
};

} // namespace toile::study::validation

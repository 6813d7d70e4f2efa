// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/Commands.h"
#include "app/batch/Console.h"
#include "core/io/DocumentFile.h"

#include <fmt/format.h>

namespace toile::batch {

int check(const std::vector<std::string>& files) {
    bool wrong = false;
    for (const std::string& file : files) {
        const auto checked = io::checkFile(file);
        if (!checked) {
            printError(checked.error());
            wrong = true;
            continue;
        }
        for (const pattern::Problem& problem : checked->problems)
            fmt::print(stderr, "{}\n", oneLine(toString(problem)));
        wrong = wrong || checked->hasErrors();
    }
    return wrong ? inputWrong : done;
}

} // namespace toile::batch

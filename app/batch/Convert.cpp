// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/Commands.h"
#include "app/batch/Console.h"
#include "app/batch/Outputs.h"
#include "core/io/DocumentFile.h"
#include "core/io/ToileFile.h"

namespace toile::batch {

int convert(const ConvertOptions& options) {
    if (const auto out = checkedOutputs({{options.out, {".toile"}}}, {options.in}); !out) {
        printError(out.error());
        return inputWrong;
    }
    auto opened = io::readDocument(options.in);
    if (!opened) {
        printError(opened.error());
        return inputWrong;
    }
    printWarnings(opened->warnings);
    std::string& avatar = opened->document.avatarFile; // the same body, named from the new place
    if (!avatar.empty()) avatar = io::nameFrom(options.out, io::fileNamedBy(options.in, avatar));
    if (const auto written = io::writeToile(opened->document, options.out); !written) {
        printError(written.error());
        return inputWrong;
    }
    return done;
}

} // namespace toile::batch

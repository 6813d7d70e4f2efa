// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/Commands.h"
#include "app/batch/Console.h"
#include "app/batch/Outputs.h"
#include "core/io/BodyImport.h"

#include <fmt/format.h>

namespace toile::batch {
namespace {

/// --under-bust gives the field underBust.
std::string optionOf(const std::string& measurement) {
    std::string option = "--";
    for (const char c : measurement)
        if ('A' <= c && c <= 'Z') option += {'-', static_cast<char>(c - 'A' + 'a')};
        else option += c;
    return option;
}

} // namespace

int avatar(const AvatarOptions& options) {
    if (const auto out = checkedOutputs({{options.out, {".glb"}}}, {}); !out) {
        printError(out.error());
        return inputWrong;
    }
    const auto mannequin = body::makeMannequin(options.measurements, options.edge);
    if (!mannequin) {
        Error error = mannequin.error();
        if (!error.place.path.empty()) error.place.path = optionOf(error.place.path);
        printError(error);
        return inputWrong;
    }
    fmt::print("{} vertices, {} triangles\n", mannequin->body.mesh.vertices.size(),
               mannequin->body.mesh.triangles.size());
    fmt::print("{:<12}{:>10}{:>10}{:>10}{:>10}\n", "girth [mm]", "asked", "tape", "section", "level");
    for (const body::Girth& girth : mannequin->girths)
        fmt::print("{:<12}{:>10.1f}{:>10.1f}{:>10.1f}{:>10.0f}\n", girth.name, 1000 * girth.asked, 1000 * girth.hull,
                   1000 * girth.section, 1000 * girth.level);
    if (const auto written = io::writeBody(options.out, mannequin->body); !written) {
        printError(written.error());
        return inputWrong;
    }
    return done;
}

} // namespace toile::batch

// SPDX-License-Identifier: GPL-3.0-or-later
// toile-make-samples FOLDER: drafts all samples and writes FOLDER/*.toile and FOLDER/bodies/*.glb.
// toile-make-samples blouse BODY OUT.toile: measures another body and drafts the blouse for it.
#include "core/io/BodyImport.h"
#include "core/io/ToileFile.h"
#include "samples/MadeToMeasure.h"
#include "samples/Samples.h"

#include <cstdio>
#include <filesystem>
#include <fmt/format.h>

using namespace toile;

namespace {

int failed(const Error& error) {
    fmt::print(stderr, "{}\n", toString(error));
    return 1;
}

int draftBlouse(const std::string& bodyFile, const std::string& out) {
    const auto body = io::readBody(bodyFile, {}, nullptr);
    if (!body) return failed(body.error());
    auto document = samples::blouseMadeToMeasure(*body);
    if (!document) return failed(document.error());
    document->avatarFile = std::filesystem::absolute(bodyFile).string();
    const auto written = io::writeToile(*document, out);
    return written ? 0 : failed(written.error());
}

} // namespace

int main(int count, char** arguments) {
    if (count == 4 && std::string_view(arguments[1]) == "blouse") return draftBlouse(arguments[2], arguments[3]);
    if (count != 2 || arguments[1][0] == '-') { // no folder called "--help"
        fmt::print(stderr, "usage: toile-make-samples FOLDER | blouse BODY OUT.toile\n");
        return 2;
    }
    const std::filesystem::path folder = arguments[1];
    const auto wearers = samples::sampleWearers();
    if (!wearers) return failed(wearers.error());

    const auto documents = samples::sampleDocuments(*wearers);
    if (!documents) return failed(documents.error());
    std::error_code created;
    std::filesystem::create_directories(folder / "bodies", created);
    for (const samples::NamedDocument& sample : *documents)
        if (const auto written = io::writeToile(sample.document, (folder / (sample.name + ".toile")).string());
            !written)
            return failed(written.error());
    for (const samples::NamedBody& sample : samples::sampleBodies(*wearers))
        if (const auto written = io::writeBody(folder / "bodies" / (sample.name + ".glb"), sample.body); !written)
            return failed(written.error());
    return 0;
}

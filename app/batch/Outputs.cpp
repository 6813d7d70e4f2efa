// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/Outputs.h"

#include "core/base/AtomicFile.h"
#include "core/base/Extension.h"
#include "core/io/FrameFiles.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace toile::batch {
namespace {

namespace fs = std::filesystem;

Result<void> checkedOutput(const Output& output) {
    const fs::path named(output.file), path = output.holdsFrames && !named.has_filename() ? named.parent_path() : named;
    const fs::path folder = path.has_parent_path() ? path.parent_path() : ".";
    std::error_code unknown;
    if (!fs::is_directory(folder, unknown))
        return fail(ErrorCode::notFound, fmt::format("There is no folder \"{}\".", folder.string()),
                    {.file = output.file});
    const std::string extension = extensionOf(path);
    if (!output.extensions.empty() && std::ranges::find(output.extensions, extension) == output.extensions.end())
        return fail(
            ErrorCode::unsupported,
            fmt::format("This cannot be written as \"{}\", only as {}.", extension, fmt::join(output.extensions, ", ")),
            {.file = output.file});
    return output.holdsFrames ? io::FrameFiles::checkWritable(path) : checkWritable(path);
}

/// Whether writing there changes what is read: the file itself, or one that lies in the folder.
bool wouldChange(const fs::path& output, const fs::path& input) {
    std::error_code unknown;
    if (areSameFile(output, input)) return true;
    return fs::is_directory(input, unknown) && fs::exists(output, unknown) &&
           areSameFile(fs::absolute(output).parent_path(), input);
}

} // namespace

Result<void> checkedOutputs(const std::vector<Output>& outputs, const std::vector<std::string>& inputs) {
    for (auto output = outputs.begin(); output != outputs.end(); ++output) {
        if (output->file.empty()) continue;
        if (auto sound = checkedOutput(*output); !sound) return sound;
        const auto overwritten = std::ranges::find_if(
            inputs, [&](const std::string& input) { return !input.empty() && wouldChange(output->file, input); });
        if (overwritten != inputs.end())
            return fail(ErrorCode::invalidInput, "This would be written over what the run reads: name another file.",
                        {.file = output->file});
        if (std::any_of(outputs.begin(), output, [&](const Output& before) {
                return !before.file.empty() && areSameFile(output->file, before.file);
            }))
            return fail(ErrorCode::invalidInput, "Two results would be written here: name another file for one.",
                        {.file = output->file});
    }
    return {};
}

bool areSameFile(const fs::path& a, const fs::path& b) {
    std::error_code unknown;
    if (fs::equivalent(a, b, unknown)) return true; // as a hard link is, too
    return fs::weakly_canonical(fs::absolute(a, unknown), unknown) ==
           fs::weakly_canonical(fs::absolute(b, unknown), unknown);
}

} // namespace toile::batch

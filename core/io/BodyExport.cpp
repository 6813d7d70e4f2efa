// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/AtomicFile.h"
#include "core/base/Extension.h"
#include "core/io/BodyGlb.h"
#include "core/io/BodyImport.h"

namespace toile::io {

Result<void> writeBody(const std::filesystem::path& path, const body::Body& body) {
    if (extensionOf(path) != ".glb")
        return fail(ErrorCode::unsupported, "Bodies are written as .glb files.", {.file = path.string()});
    if (body.mesh.triangles.empty())
        return fail(ErrorCode::invalidInput, "The body has no triangles to write.", {.file = path.string()});
    return writeFileAtomically(path, toBytes(glbOf(body)));
}

} // namespace toile::io

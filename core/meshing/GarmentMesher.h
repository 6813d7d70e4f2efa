// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/GarmentMesh.h"

#include <memory>

namespace toile::meshing {

/// How much of a garment had to be made anew.
struct MeshingWork {
    int checkedPieces = 0; ///< whose border went through the gate
    int meshedPieces = 0;
};

/// Meshes a garment again and again while it is edited. Remembers what each piece's mesh was made of; where nothing of
/// it has changed, the mesh stays. What comes out is what meshGarment gives, node for node.
class GarmentMesher {
public:
    explicit GarmentMesher(MeshSettings settings = {});
    ~GarmentMesher();
    GarmentMesher(GarmentMesher&&) noexcept;
    GarmentMesher& operator=(GarmentMesher&&) noexcept;

    /// The mesh belongs to the mesher and stands until the next call. Errors name piece, edge and point; after one the
    /// mesher still remembers what it can.
    [[nodiscard]] Result<const GarmentMesh*> mesh(const MeshInput& input);

    /// Forgets what the pieces' meshes were made of, but keeps the memory: the next call meshes all anew in it.
    void forget();

    /// The last mesh, out of a mesher that is done.
    [[nodiscard]] GarmentMesh take() &&;

    /// Of the last call.
    [[nodiscard]] MeshingWork work() const;

private:
    struct Memory;
    std::unique_ptr<Memory> memory_;
};

} // namespace toile::meshing

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QWidget;

namespace toile::ui {

/// What is being typed into a field of the window becomes the field's value, as if the field had been left; the
/// keyboard stays where it was. Called before anything is done with the document: it is to be what the window shows.
void takeTyped(QWidget& window);

} // namespace toile::ui

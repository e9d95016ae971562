#pragma once

#include "core/describe/command_options.h"
#include "core/study/elements/place_elements.h"

namespace noonmark {

/// All settings of points but what their names mean (ElementParts), which no user sets.
const Fields<ElementSettings>& elementFields();

/// Parts of that table, for commands that take some of its options.
const Fields<ElementSettings>& facadeFields();         ///< bays and storeys
const Fields<ElementSettings>& aboveFloorFields();     ///< the points' height in their storey
const Fields<ElementSettings>& lineFields();           ///< the parcel and the lines around it
const Fields<ElementSettings>& planeFields();          ///< the height of a plane
const Fields<ElementSettings>& pointsFileFields();     ///< the file of points
const Fields<ElementSettings>& windowsFields();        ///< the file of windows
const Fields<WindowFileSettings>& windowFileFields();  ///< how the file of windows is read
const Fields<FaceChoice>& faceFields();                ///< the faces that are measured

/// The options of `study` that ask for the same points. Files are named without their folders, as the
/// command is run beside them.
std::vector<CommandOption> listElementOptions(const ElementSettings& elements);

}  // namespace noonmark

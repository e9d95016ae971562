#pragma once

#include "core/describe/command_options.h"
#include "core/study/elements/place_elements.h"

namespace noonmark {

/// All settings of points but what their names mean (ElementParts), which no user sets.
const Fields<ElementSettings>& elementFields();

/// Parts of that table, for commands that take some of its options.
const Fields<ElementSettings>& receiverFields();         ///< which kind of points
const Fields<ElementSettings>& facadeFields();           ///< bays and storeys
const Fields<ElementSettings>& aboveFloorFields();       ///< the points' height in their storey
const Fields<ElementSettings>& lineFields();             ///< the parcel and the lines around it
const Fields<ElementSettings>& planeFields();            ///< the height of a plane
const Fields<ElementSettings>& pointsFileFields();       ///< the file of points
const Fields<ElementSettings>& glazingFields();          ///< the file of windows
const Fields<GlazingFileSettings>& glazingFileFields();  ///< how the file of windows is read
const Fields<FaceChoice>& faceFields();                  ///< the faces that are measured

/// What a command line states in other words: whose facades, and points one by one.
const Fields<ElementSettings>& facadesOfFields();
const Fields<ElementSettings>& pointFields();

/// Names all buildings where names are expected.
inline constexpr std::string_view allFacades = "all";

/// The options of `study` that ask for the same points. Files are named without their folders, as the
/// command is run beside them.
std::vector<CommandOption> listElementOptions(const ElementSettings& elements);

}  // namespace noonmark

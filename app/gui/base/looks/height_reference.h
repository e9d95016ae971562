#pragma once

class QSettings;

namespace noonmark {

/// From where the window counts heights of buildings and towers, as shown and as typed. Files and results are
/// not affected.
enum class HeightReference {
    ground,  ///< the ground under the building
    datum,   ///< the vertical zero of the project's terrain or, without terrain, the ground at the origin
};

/// The reference saved in the settings; the ground at first.
HeightReference readHeightReference(const QSettings& settings);
void saveHeightReference(HeightReference reference, QSettings& settings);

/// For the whole application. Texts and fields that are already shown do not change by themselves.
void applyHeightReference(HeightReference reference);
HeightReference heightReferenceInUse();  ///< the ground before applyHeightReference()

}  // namespace noonmark

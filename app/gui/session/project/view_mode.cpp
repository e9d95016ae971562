#include "app/gui/session/project/view_mode.h"

#include <QObject>

namespace noonmark {

QString nameOf(ViewMode mode) {
    if (mode == ViewMode::exploration) return QObject::tr("Exploration");
    return mode == ViewMode::analysis ? QObject::tr("Analysis") : QObject::tr("Ray reference");
}

QString describeMeasure(ViewMode mode) {
    if (mode == ViewMode::exploration)
        return QObject::tr(
            "Shadow on all visible surfaces: ground, roofs and facades.\nUpdated when the view or the period "
            "changes, coarse at first, then pixel by pixel.");
    if (mode == ViewMode::analysis)
        return QObject::tr(
            "Shadow on the ground of the region, cell by cell, with figures, report and files.\n"
            "Computed by the engine of the study when you press Run.");
    return QObject::tr(
        "Like the analysis, but with one ray per cell and minute:\nthe slow, exact reference for the other "
        "engines.");
}

}  // namespace noonmark

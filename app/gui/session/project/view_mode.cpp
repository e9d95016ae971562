#include "app/gui/session/project/view_mode.h"

#include <QObject>

namespace noonmark {

QString nameOf(ViewMode mode) {
    if (mode == ViewMode::exploration) return QObject::tr("Now");
    return mode == ViewMode::analysis ? QObject::tr("Study") : QObject::tr("Review");
}

QString describeMeasure(ViewMode mode) {
    if (mode == ViewMode::exploration)
        return QObject::tr(
            "Sun and shadow of a moment or a period on all visible surfaces: ground, roofs and facades.\n"
            "Updated when the view or the time changes, coarse at first, then pixel by pixel.");
    if (mode == ViewMode::analysis)
        return QObject::tr(
            "Shadow on the ground of the region, cell by cell, with figures, report and files.\n"
            "Computed by the engine of the study when you press Run.");
    return QObject::tr(
        "Verdicts by the rules of review boards, of a proposal or of the existing city.\nOpens the panel "
        "Review.");
}

}  // namespace noonmark

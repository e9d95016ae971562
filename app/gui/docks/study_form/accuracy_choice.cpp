#include "app/gui/docks/study_form/accuracy_choice.h"

#include <QObject>

namespace noonmark {

namespace {

constexpr std::string_view automatic = "auto", polygons = "projected", inverseMaps = "iam";

std::string_view engineOf(AccuracyChoice choice, const StudySettings& settings, bool terrain) {
    const bool level = !terrain && settings.receivers.places == ReceiverPlaces::ground;
    if (choice == AccuracyChoice::quick) return automatic;
    if (choice == AccuracyChoice::exact && level) return polygons;
    return referenceEngine;
}

StudySettings withEngine(StudySettings settings, std::string_view engine) {
    settings.engine = std::string(engine);
    settings.engineSettings.clear();
    return settings;
}

}  // namespace

QString nameOf(AccuracyChoice choice) {
    switch (choice) {
        case AccuracyChoice::quick:
            return QObject::tr("Quick");
        case AccuracyChoice::exact:
            return QObject::tr("Exact");
        case AccuracyChoice::reference:
            return QObject::tr("Reference (rays)");
        case AccuracyChoice::own:
            return QObject::tr("Own settings");
    }
    return {};
}

QString describe(AccuracyChoice choice) {
    switch (choice) {
        case AccuracyChoice::quick:
            return QObject::tr(
                "Exact where that is quick; over long periods off by 0.04 % of the time on average, and the "
                "error is measured");
        case AccuracyChoice::exact:
            return QObject::tr("The outline of every shadow at every step, without rounding");
        case AccuracyChoice::reference:
            return QObject::tr("One ray for every cell and step: what the other ways are checked against");
        case AccuracyChoice::own:
            return QObject::tr("The method and the options chosen below");
    }
    return {};
}

StudySettings applied(AccuracyChoice choice, StudySettings settings, bool terrain) {
    if (choice == AccuracyChoice::own) return settings;
    return withEngine(settings, engineOf(choice, settings, terrain));
}

AccuracyChoice choiceOf(const StudySettings& settings, bool terrain) {
    if (!settings.engineSettings.empty()) return AccuracyChoice::own;
    for (const AccuracyChoice choice :
         {AccuracyChoice::quick, AccuracyChoice::reference, AccuracyChoice::exact})
        if (settings.engine == engineOf(choice, settings, terrain)) return choice;
    return AccuracyChoice::own;
}

StudySettings asInPaper(StudySettings settings) { return withEngine(std::move(settings), inverseMaps); }

}  // namespace noonmark

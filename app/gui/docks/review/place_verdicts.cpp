#include "app/gui/docks/review/place_verdicts.h"

#include <QObject>
#include <array>
#include <map>

#include "app/gui/docks/review/glazing/verdict_tiles.h"
#include "app/gui/docks/review/verdict_words.h"
#include "core/describe/text.h"

namespace noonmark {

namespace {

constexpr std::array colouredVerdicts{Verdict::pass, Verdict::borderline, Verdict::fail,
                                      Verdict::notApplicable};

/// A place with its reviews, by their index in the answer's study.
struct ColouredPlace {
    Place place;
    std::vector<std::size_t> reviews;
};

std::vector<ColouredPlace> listPlaces(const ReviewAnswer& answer) {
    std::vector<ColouredPlace> places;
    std::map<std::string, std::size_t> known;
    for (std::size_t i = 0; i < answer.study.places.size(); ++i) {
        const Place& place = answer.placeOf(i);
        const auto [at, isNew] = known.try_emplace(place.name, places.size());
        if (isNew) places.push_back({place, {}});
        places[at->second].reviews.push_back(i);
    }
    return places;
}

Verdict worstOf(const ReviewAnswer& answer, const ColouredPlace& place) {
    Verdict worst = answer.study.places[place.reviews.front()].verdict;
    for (const std::size_t review : place.reviews)
        if (isWorse(worst, answer.study.places[review].verdict)) worst = answer.study.places[review].verdict;
    return worst;
}

// The words of legends are English here, as in files.
Legend makeVerdictLegend(const ReviewAnswer& answer) {
    Legend legend;
    legend.title = QStringLiteral(NM_TEXT("Verdicts on places"));
    legend.unit = QString::fromStdString(answer.question.rule.name);
    for (const Verdict verdict : colouredVerdicts)
        legend.classes.push_back({tileColour(verdict), QString::fromUtf8(nameOf(verdict).data())});
    return legend;
}

QString describe(const ReviewAnswer& answer, const ColouredPlace& place) {
    QStringList verdicts;
    for (const std::size_t review : place.reviews) verdicts << describeVerdict(answer.study.places[review]);
    return QObject::tr("%1   %2").arg(QString::fromStdString(place.place.name), verdicts.join(u' '));
}

GroundPicture::Pixel pixelOf(const QColor& colour) {
    return {std::uint8_t(colour.red()), std::uint8_t(colour.green()), std::uint8_t(colour.blue()), 255};
}

}  // namespace

std::shared_ptr<const PlaceView> makePlaceVerdicts(const std::shared_ptr<const ReviewAnswer>& answer) {
    if (!answer || answer->study.places.empty()) return nullptr;
    const auto places = std::make_shared<const std::vector<ColouredPlace>>(listPlaces(*answer));
    std::vector<Place> shapes;
    std::vector<GroundPicture::Pixel> colours;
    for (const ColouredPlace& place : *places) {
        shapes.push_back(place.place);
        colours.push_back(pixelOf(tileColour(worstOf(*answer, place))));
    }
    const auto painted = std::make_shared<const PlacePicture>(shapes);
    const auto view = std::make_shared<PlaceView>();
    view->picture = painted->coloured(colours);
    view->legend = makeVerdictLegend(*answer);
    view->note =
        QObject::tr("%1 compared with %2")
            .arg(QString::fromStdString(answer->question.to), QString::fromStdString(answer->question.from));
    view->describe = [answer, places, painted](glm::dvec2 point) {
        const auto place = painted->placeAt(point);
        return place ? describe(*answer, (*places)[*place]) : QString();
    };
    return view;
}

}  // namespace noonmark

#pragma once

#include <QWidget>
#include <vector>

#include "app/report/maps/answer_legends.h"
#include "core/base/result.h"

namespace noonmark {

/// The part of a city where most buildings stand, ready to be drawn: prisms, those farther north first.
struct MassingSketch {
    struct Prism {
        Ring outline;                 ///< counter-clockwise, local metres
        float bottomM = 0, topM = 0;  ///< above the ground
        HeightSource source = HeightSource::assumed;
    };
    std::vector<Prism> prisms;
    Box2 box;
    float tallestM = 0;  ///< of the prisms
    std::size_t buildings = 0;
    SourceCounts sources{};
    /// Heights of the tops of the city's buildings above their ground; negative: below it.
    float lowM = 0, medianM = 0, highM = 0;
};

/// At most some 700 m of the city, so that single buildings can be told apart. O(buildings).
MassingSketch sketchMassing(const City& city);

/// A small picture of the massing that a file gives as it would be read, coloured by where the heights come
/// from, with counts and range of heights in words.
class MassingPreview final : public QWidget {
    Q_OBJECT
public:
    explicit MassingPreview(QWidget* parent = nullptr);

    void showWaiting();
    void show(Result<MassingSketch> sketch);  ///< or why there is none
    [[nodiscard]] QString words() const;
    [[nodiscard]] QSize sizeHint() const override { return {360, 420}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    [[nodiscard]] QString describeLowest() const;

    Result<MassingSketch> sketch_;
    bool waiting_ = false;
};

}  // namespace noonmark

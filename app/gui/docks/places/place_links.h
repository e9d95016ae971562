#pragma once

#include <QObject>
#include <QPointF>
#include <memory>

namespace noonmark {

class MeasuredAnswer;
class PlacesDock;
class ResultDisplay;
struct SunOfCities;
class ViewPanel;
class Workbench;

/// Shows the workbench's answer about sun by place in its table and in the view, new or saved, and connects
/// both: the current row is outlined in the view, a click on a place selects its row. While another answer is
/// displayed the table stays, set aside, and brings its own back.
class PlaceLinks final : public QObject {
    Q_OBJECT
public:
    /// All must outlive this object.
    PlaceLinks(Workbench& workbench, const ResultDisplay& display, PlacesDock& dock, ViewPanel& panel);

Q_SIGNALS:
    void placeRequested(const std::string& name);         ///< to be seen in the view
    void contributorsRequested(const std::string& name);  ///< what buildings take from it is to be shown
    void dockRequested();                                 ///< another answer about places
    void chosen(std::size_t place);                       ///< in table or view

private:
    void follow();
    void paint();
    void keep(std::shared_ptr<const SunOfCities> sun);
    [[nodiscard]] QString nameOfKept() const;
    void showKept();
    void click(QPointF pixel);
    [[nodiscard]] const std::string& nameOf(std::size_t place) const;

    Workbench& workbench_;
    PlacesDock& dock_;
    ViewPanel& panel_;
    /// The answer about places that was displayed last: in this session, or a saved one of this name.
    struct Kept {
        std::shared_ptr<const SunOfCities> sun;
        std::shared_ptr<const MeasuredAnswer> measured;
        std::string saved;
    };
    Kept kept_;
    bool isDisplayed_ = false;  ///< by the view and the results
};

}  // namespace noonmark

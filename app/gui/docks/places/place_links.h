#pragma once

#include <QObject>
#include <QPointF>

namespace noonmark {

class PlacesDock;
class ResultDisplay;
class ViewPanel;
class Workbench;

/// Shows the workbench's answer about sun by place in its table and in the view, new or saved, and connects
/// both: the current row is outlined in the view, a click on a place selects its row.
class PlaceLinks final : public QObject {
    Q_OBJECT
public:
    /// All must outlive this object.
    PlaceLinks(Workbench& workbench, const ResultDisplay& display, PlacesDock& dock, ViewPanel& panel);

Q_SIGNALS:
    void placeWanted(const std::string& name);         ///< to be seen in the view
    void contributorsWanted(const std::string& name);  ///< what buildings take from it is to be shown
    void dockWanted();                                 ///< another answer about places
    void chosen(std::size_t place);                    ///< in table or view

private:
    void follow();
    void click(QPointF pixel);
    [[nodiscard]] const std::string& nameOf(std::size_t place) const;

    Workbench& workbench_;
    PlacesDock& dock_;
    ViewPanel& panel_;
};

}  // namespace noonmark

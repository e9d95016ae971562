#pragma once

#include <QObject>
#include <QPointF>

namespace noonmark {

class ElementsDock;
class ViewPanel;

/// Connects the table of points with the view: selected rows are outlined there, a click on a point selects
/// its row.
class ElementLinks final : public QObject {
    Q_OBJECT
public:
    ElementLinks(ElementsDock& dock, ViewPanel& panel);  ///< both must outlive this object

private:
    void goTo(std::size_t element);
    void click(QPointF pixel);

    ElementsDock& dock_;
    ViewPanel& panel_;
};

}  // namespace noonmark

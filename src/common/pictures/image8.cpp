#include "common/pictures/image8.h"

namespace infra {

void paste(Image8& target, const Image8& source, int x, int y) {
    for (int row = 0; row < source.height; ++row)
        for (int column = 0; column < source.width; ++column)
            target.set(x + column, y + row, source.at(column, row));
}

}  // namespace infra

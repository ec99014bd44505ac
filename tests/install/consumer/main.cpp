#include <core/random.h>
#include <io/csv.h>

#include <iostream>

int main() {
    dsc::core::Random random(1);
    dsc::io::CsvWriter table("points.csv", {"u", "v"});
    for (int i = 0; i < 10; ++i) table.row({random.uniform(), random.uniform()});
    table.commit();
    std::cout << "wrote " << dsc::io::read_csv("points.csv").rows.size() << " rows\n";
}

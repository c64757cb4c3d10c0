# Flags shared by every target.
# restrict: g++ 12 sees it in std::string sums where there is none (GCC bug 105651).
add_compile_options(-Wall -Wextra -Wshadow -Wno-missing-field-initializers -Wno-restrict)
if(INFRADIANCE_WERROR)
    add_compile_options(-Werror)
endif()

# No errno from <cmath> and no trapping arithmetic: sqrt, floor and comparisons become single instructions.
# Neither changes a result, so NaN and infinity keep their IEEE meaning (-ffast-math would not keep it).
add_compile_options(-fno-math-errno -fno-trapping-math)

# A picture must not depend on which lines the compiler chose to fuse.
add_compile_options(-ffp-contract=off)

if(INFRADIANCE_SANITIZE)
    add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
    add_link_options(-fsanitize=address,undefined)
    # Instrumented code confuses g++ 12 about std::variant and std::optional.
    add_compile_options(-Wno-maybe-uninitialized)
endif()

# What the scripts here share: installs what is missing, builds for a target, runs in QEMU, looks into programs.
# To be sourced, in the folder of this file.
PATH="$HOME/.cargo/bin:$PATH"
m4_hard=thumbv7em-none-eabihf
m4_soft=thumbv7em-none-eabi
m0=thumbv6m-none-eabi

has_target() { [ -d "$(rustc --print sysroot)/lib/rustlib/$1/lib" ]; }

install() { # packages...
    if ! dpkg -s "$@" >/dev/null 2>&1; then
        apt-get update -qq
        apt-get install -y -qq --no-install-recommends "$@" >/dev/null
    fi
}

# Cargo for a target that is installed (`rustup target add`), else Debian's compiler with its library source.
cargo_for() { # target, command, its arguments...
    local target=$1 command=$2
    shift 2
    if has_target "$target"; then
        cargo "$command" --quiet --locked --release --target "$target" -p hooke-firmware "$@"
        return
    fi
    install rustc-web cargo-web rust-web-src rust-web-clippy lld-16
    local name=${target//-/_}
    # Building the library from source is not in the stable compiler's interface, hence the variable.
    env "CARGO_TARGET_${name^^}_LINKER=ld.lld-16" RUSTC_BOOTSTRAP=1 RUSTC=/usr/bin/rustc PATH="/usr/bin:$PATH" \
        /usr/bin/cargo "$command" --quiet --locked --release --target "$target" -Zbuild-std=core,compiler_builtins \
        -p hooke-firmware "$@"
}

build() { # target, arguments of cargo build...
    cargo_for "$1" build "${@:2}"
}

lint() { # target, arguments of cargo clippy...
    cargo_for "$1" clippy "${@:2}" -- -D warnings
}

emulate() { # machine, program: ends with the program's exit code, or with a failure after ten minutes
    timeout --kill-after=10 600 qemu-system-arm -machine "$1" -nographic -icount shift=0 \
        -semihosting-config enable=on,target=native -kernel "$2" </dev/null
}

# Bytes of flash: code, constants, and the initial values of statics.
flash() { # program
    local sum=0 size
    while read -r size; do sum=$((sum + size)); done < <(readelf -lW "$1" | awk '$1 == "LOAD" { print $5 }')
    echo "$sum"
}

# Bytes of RAM that statics take.
ram() { # program
    local sum=0 address size
    while read -r address size; do
        [ $((address)) -lt $((0x20000000)) ] || sum=$((sum + size))
    done < <(readelf -lW "$1" | awk '$1 == "LOAD" { print $3, $6 }')
    echo "$sum"
}

# The functions in a program that a panic goes through.
panics() { # program
    readelf -sW "$1" | awk '$8 ~ /9panicking|rust_begin_unwind/ { print $8 }' | sort -u
}

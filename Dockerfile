# Crevice on a bare Debian 12, for systems that are not Debian. The demo, its pages handed out into out/:
#   docker build -t crevice . && docker run --rm -v "$PWD/out:/crevice/out" crevice
# The tests: docker run --rm crevice ./crevice.sh test
FROM debian:12
WORKDIR /crevice
COPY . .
RUN ./crevice.sh scenes
CMD ["./crevice.sh", "demo"]
